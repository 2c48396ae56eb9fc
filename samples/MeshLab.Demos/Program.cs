using MeshLab.Demos.Hosting;

return DemoProgram.Run(args);
